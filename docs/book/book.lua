-- Makes one document of the pages that FOLDER/README.md links, in that order: pandoc -M folder=FOLDER --lua-filter book.lua.
-- A link to a page of the book leads there; any other is printed as its words. What cannot be set is an error.

local function fail(what) error(what, 0) end

local function contents(path)
  local file = io.open(path) or fail('cannot read ' .. path)
  local text = file:read('a')
  file:close()
  return text
end

local function plain(path) -- a/b/../c.md is a/c.md
  local found
  repeat path, found = path:gsub('[^/.]+/%.%./', '', 1) until found == 0
  return path
end

local function latex(text) return pandoc.RawInline('latex', text) end

-- Names and paths break at their signs: a line of a table is short.
local function breaking(text)
  text = text:gsub('[\\{}$&#%^_~%%]', function(sign)
    return ({['\\'] = '\\textbackslash{}', ['^'] = '\\textasciicircum{}', ['~'] = '\\textasciitilde{}'})[sign] or '\\' .. sign
  end)
  return (text:gsub('[_/:,=.(-]', '%0\\allowbreak{}'))
end

local function code(element) return latex('\\texttt{' .. breaking(element.text) .. '}') end

-- What is wider than the page is set smaller; its number stays beside it.
local function formula_of(element)
  if element.mathtype ~= 'DisplayMath' then return nil end
  local formula, tag = element.text:match('^(.-)%s*(\\tag{%w+})%s*$')
  return latex('\\[\\fit{' .. (formula or element.text) .. '}' .. (tag or '') .. '\\]')
end

local function words(element)
  local text = element.text
  if text:find('$', 1, true) then fail('a formula is not read: ' .. text) end
  if text:find('[□−/_]') then
    return latex((breaking(text):gsub('□', '\\ensuremath{\\square}'):gsub('−', '\\ensuremath{-}')))
  end
end

-- Each column as wide as its longest cell asks, up to a limit.
local function columns(element)
  local widths, sum = {}, 0
  for i in ipairs(element.colspecs) do widths[i] = 6 end
  local function row(cells)
    for i, cell in ipairs(cells) do
      widths[i] = math.max(widths[i], math.min(#pandoc.utils.stringify(cell.contents), 50))
    end
  end
  for _, head in ipairs(element.head.rows) do row(head.cells) end
  for _, body in ipairs(element.bodies) do
    for _, line in ipairs(body.body) do row(line.cells) end
  end
  for _, width in ipairs(widths) do sum = sum + width end
  for i, column in ipairs(element.colspecs) do element.colspecs[i] = {column[1], widths[i] / math.max(sum, 60)} end
  return element
end

local function chapter(path, pages)
  local folder = path:match('^(.*/)')
  local function name(target) return target:gsub('[^%w]', '-') end
  local document = pandoc.read(contents(path), 'gfm+tex_math_dollars')
  return document.blocks:walk({Table = columns}):walk {
    Header = function(element)
      element.identifier = name(path) .. (element.level > 1 and '-' .. element.identifier or '')
      return element
    end,
    Link = function(element)
      if element.target:match('^%a+:') then return nil end
      local page, anchor = element.target:match('^([^#]*)#?(.*)$')
      page = page == '' and path or plain(folder .. page)
      if not pages[page] then return element.content end
      element.target = '#' .. name(page) .. (anchor ~= '' and '-' .. anchor or '')
      return element
    end,
    Image = function(element)
      element.src = plain(folder .. element.src)
      return element
    end,
    Code = code, Math = formula_of, Str = words,
  }
end

function Pandoc(document)
  local folder = pandoc.utils.stringify(document.meta.folder)
  local order, pages = {}, {}
  for page in contents(folder .. '/README.md'):gmatch('%]%(([%w/._-]+%.md)') do
    local path = plain(folder .. '/' .. page)
    if path:sub(1, #folder + 1) == folder .. '/' and not pages[path] and not page:match('^reference/') then
      pages[path] = true
      order[#order + 1] = path
    end
  end
  for _, path in ipairs(order) do document.blocks:extend(chapter(path, pages)) end
  return document
end
